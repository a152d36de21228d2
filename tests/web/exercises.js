module.exports=[];
